"""Programs of robot servers: their page, questions and commands of the shell."""
