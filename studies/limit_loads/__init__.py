"""Limit loads: small bodies of the pressure-dependent and the kinematic laws, loaded slowly until they flow."""
