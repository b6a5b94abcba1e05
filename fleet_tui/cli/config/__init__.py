"""The `config` command: create or explain a configuration."""
