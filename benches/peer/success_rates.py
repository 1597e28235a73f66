"""How often pyswarms finds the known minima that `optim`'s example success_rates looks for, with the same parameters.

    success_rates.py

100 seeds, 50 particles, 500 iterations, w = 0.7, c1 = c2 = 1.5; a success is a value below 1e-5. pyswarms has the global
topology only as its default; positions that leave the box are put back by its own rule.
"""

import logging

import numpy as np
import pyswarms

logging.disable(logging.CRITICAL)
SEEDS, PARTICLES, ITERATIONS = 100, 50, 500


def sphere(x):
    return np.sum(x * x, axis=1)


def rosenbrock(x):
    return np.sum((1 - x[:, :-1]) ** 2 + 100 * (x[:, 1:] - x[:, :-1] ** 2) ** 2, axis=1)


def rastrigin(x):
    return np.sum(x * x + 10 * (1 - np.cos(2 * np.pi * x)), axis=1)


def ackley(x):
    root = np.sqrt(np.mean(x * x, axis=1))
    wave = np.mean(np.cos(2 * np.pi * x), axis=1)
    return 20 * (1 - np.exp(-0.2 * root)) + np.e - np.exp(wave)


def griewank(x):
    wave = np.prod(np.cos(x / np.sqrt(np.arange(1, x.shape[1] + 1))), axis=1)
    return 1 + sphere(x) / 4000 - wave


PROBLEMS = [
    ("sphere", sphere, 5.0),
    ("Rosenbrock", rosenbrock, 2.0),
    ("Rastrigin", rastrigin, 5.12),
    ("Ackley", ackley, 30.0),
    ("Griewank", griewank, 100.0),
]


def found(function, dimension, side, seed):
    np.random.seed(seed)
    swarm = pyswarms.single.GlobalBestPSO(
        n_particles=PARTICLES,
        dimensions=dimension,
        options={"w": 0.7, "c1": 1.5, "c2": 1.5},
        bounds=(np.full(dimension, -side), np.full(dimension, side)),
    )
    value, _ = swarm.optimize(function, iters=ITERATIONS, verbose=False)
    return value < 1e-5


print(f"pyswarms {pyswarms.__version__}: successes of {SEEDS} seeds\n")
print("function     dimension   global")
for name, function, side in PROBLEMS:
    for dimension in (2, 3, 4):
        successes = sum(found(function, dimension, side, seed) for seed in range(SEEDS))
        print(f"{name:<10}   {dimension:>9}   {successes:>6}", flush=True)
