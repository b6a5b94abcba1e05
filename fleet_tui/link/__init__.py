"""The door to the robots: connections, subscriptions, calls with deadlines."""
