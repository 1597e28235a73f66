#!/bin/sh
#SBATCH --array=1-8
#SBATCH --cpus-per-task=1
#SBATCH --output=slurm-%A-%a.log
#SBATCH --open-mode=append
plateau run sweep.toml --threads 1
