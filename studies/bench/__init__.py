"""The speed of this machine: `matpoint bench`."""
