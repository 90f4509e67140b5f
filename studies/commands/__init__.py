"""The verbs of the command `matpoint`, one module each: add_options(parser), execute(options) -> status."""
