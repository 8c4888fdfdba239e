#!/bin/sh
# Removes from an environment with c4s what c4s never opens: headers of C++ libraries, and the test suites of NumPy,
# SciPy, pandas, numba, pyarrow and shapely. `python -m bench.installed` tells how much that is.
#   sh deploy/slim.sh FOLDER      the environment: it holds bin/ and lib/
set -eu
for packages in "${1:?which environment?}"/lib/python3.*/site-packages; do
  test -d "$packages/c4s" || { echo "slim.sh: $packages holds no c4s" >&2; exit 2; }
  rm -rf "$packages/cmeel.prefix/include" "$packages/pyarrow/include"
  for name in numpy scipy pandas numba pyarrow shapely; do
    find "$packages/$name" -type d -name tests -prune -exec rm -rf {} +
  done
done
