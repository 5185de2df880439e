\\ SPDX-License-Identifier: MIT
\\ System (49) by PARI/GP, in rational functions of several variables: matsolve, or Cramer's rule,
\\ every determinant by matdet. Order N and method are set before this is read. c_0 = 1; the other
\\ 2N + 1 unknowns from rows k = 0 .. 2N. The time depends on the order of the variables: a_(2N-1)
\\ first, then .. a_1, dX is the fastest found.
forstep(k = 2*N - 1, 1, -2, eval(Str("a", k)));
eval("dX");
coefficient(k) = if(k % 2, eval(Str("a", k)), 0);
power(j, k) = if(k == 0, 1, (j*dX)^k/k!);  \\ h_kj of (51)
left(j, k) = sum(i = 1, k, coefficient(i)*power(j, k - i));
A() = matrix(2*N + 1, 2*N + 1, r, j, if(j <= N, left(j, r - 1), -power(j - N - 1, r - 1)));
right() = vectorv(2*N + 1, r, -left(0, r - 1));
by_matsolve() = matsolve(A(), right());
by_cramer() =
{
  my(M = A(), r = right(), d = matdet(M));
  vectorv(2*N + 1, j, my(other = M); other[, j] = r; matdet(other)/d);
}

calls = 0;
taken = 0;
start = getabstime();  \\ milliseconds of processor time
solve_49() = if(method == "cramer", by_cramer(), by_matsolve());
while(taken < 200, solution = solve_49(); calls++; taken = getabstime() - start);
printf("seconds %.9f\n", taken/calls/1000.);

at_numbers(value) =
{
  forstep(k = 1, 2*N - 1, 2, value = subst(value, coefficient(k), (k^2 % 11 + 1)/(k + 2)));
  subst(value, dX, 3/7);
}
print("value 1");
for(j = 1, 2*N + 1, print("value ", at_numbers(solution[j])));
