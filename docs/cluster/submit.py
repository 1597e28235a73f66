"""The cells of sweep.toml as an array of eight jobs, by submitit: pip install submitit."""
import subprocess

import submitit

SHARDS = 8


def shard(k: int) -> int:
    return subprocess.run(["plateau", "run", "sweep.toml", "--shard", f"{k}/{SHARDS}", "--threads", "1"]).returncode


executor = submitit.AutoExecutor(folder="submitit")  # Slurm where there is one, else this machine
executor.update_parameters(timeout_min=60, cpus_per_task=1)
jobs = executor.map_array(shard, range(1, SHARDS + 1))
assert all(job.result() == 0 for job in jobs)
