"""Flow stress laws."""
