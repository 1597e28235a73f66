"""The cells of sweep.toml as eight tasks of HyperQueue, on this machine: pip install hyperqueue.

On a cluster the same is one line: hq submit --array 1-8 --cpus 1 plateau run sweep.toml --shard /8 --threads 1
"""
from hyperqueue import Job, LocalCluster

SHARDS = 8
with LocalCluster() as cluster:
    cluster.start_worker()
    client = cluster.client()
    job = Job(max_fails=None)  # one shard that fails ends no other
    for k in range(1, SHARDS + 1):
        command = ["plateau", "run", "sweep.toml", "--shard", f"{k}/{SHARDS}", "--threads", "1"]
        job.program(command, stdout=None, stderr=f"shard-{k}.log")
    client.wait_for_jobs([client.submit(job)])
