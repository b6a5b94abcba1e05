"""The command line: arguments, options, and the commands without a screen."""
