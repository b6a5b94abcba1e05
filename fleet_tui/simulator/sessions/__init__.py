"""Connected clients: their operations, subscriptions and outgoing frames."""
