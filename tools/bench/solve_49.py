# SPDX-License-Identifier: MIT
"""System (49) by SymPy: LU decomposition over the field Q(a_1, a_3, .., dX), or Cramer's rule with
determinants without division over Q[a_1, a_3, .., dX] (DomainMatrix; solve and linsolve, which
build on it, take longer). Usage: solve_49.py N lu|cramer. c_0 = 1; the other 2N + 1 unknowns from
rows k = 0 .. 2N."""
import sys
import time

from sympy import QQ, Matrix, Rational, Symbol, factorial
from sympy.polys.matrices import DomainMatrix

N = int(sys.argv[1])
a = [Symbol(f"a{k}") if k % 2 else 0 for k in range(2 * N + 1)]
dX = Symbol("dX")
symbols = [*a[:0:-1][1::2], dX]  # a_(2N-1) first is the fastest order found
numbers = {a[k]: Rational(k * k % 11 + 1, k + 2) for k in range(1, 2 * N, 2)} | {dX: Rational(3, 7)}


def power(j, k):
    """h_kj of (51)"""
    return (j * dX) ** k / factorial(k) if k else 1


def left(j, k):
    return sum(a[i] * power(j, k - i) for i in range(1, k + 1))


def system(domain):
    rows = range(2 * N + 1)
    A = Matrix([[left(j, k) for j in range(1, N + 1)] + [-power(j, k) for j in range(N + 1)]
                for k in rows])
    right = Matrix([-left(0, k) for k in rows])
    return [DomainMatrix.from_Matrix(matrix).convert_to(domain) for matrix in (A, right)]


def by_lu():
    A, right = system(QQ.frac_field(*symbols))
    return [row[0] for row in A.lu_solve(right).to_Matrix().tolist()]


def by_cramer():
    A, right = system(QQ[tuple(symbols)])
    domain = A.domain
    A, right = A.to_Matrix().tolist(), right.to_Matrix().tolist()

    def determinant(rows):
        matrix = DomainMatrix.from_Matrix(Matrix(rows)).convert_to(domain)
        return domain.to_sympy(matrix.charpoly()[-1])  # of odd size: -det, in all of them

    whole = determinant(A)
    return [(determinant([row[:j] + r + row[j + 1:] for row, r in zip(A, right)]), whole)
            for j in range(2 * N + 1)]


def at_numbers(value):
    if isinstance(value, tuple):
        return at_numbers(value[0]) / at_numbers(value[1])
    return value.subs(numbers)


calls = 0
start = time.process_time()
while True:
    solution = {"lu": by_lu, "cramer": by_cramer}[sys.argv[2]]()
    calls += 1
    taken = time.process_time() - start
    if taken >= 0.2:
        break
print("seconds", taken / calls)
print("value 1")
for value in solution:
    print("value", at_numbers(value))
