"""Many independent jobs: on a Dask cluster, or in processes of this machine; one that fails never stops the others."""
