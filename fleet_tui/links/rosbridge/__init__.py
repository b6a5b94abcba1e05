"""Links to rosbridge servers: subscriptions, calls, goals, publications."""
