"""The verbs of the command `matpoint`, one module each: add_options(parser) and execute(options) -> exit status."""
