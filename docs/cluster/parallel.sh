#!/bin/sh
# As many at a time as there are processors; --sshlogin host1,host2 for those of other machines that see the same folder.
seq 8 | parallel plateau run sweep.toml --shard {}/8 --threads 1
plateau merge out/sweep
