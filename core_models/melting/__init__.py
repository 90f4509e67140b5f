"""Melting temperature laws."""
