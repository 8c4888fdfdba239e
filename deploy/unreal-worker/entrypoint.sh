#!/bin/sh
# A worker of the pool `engines` on this host, or any other c4s command: `docker run IMAGE c4s engine conform ...`.
set -eu

if [ "$#" -gt 0 ]; then
  exec "$@"
fi
if [ -z "${PREFECT_API_URL:-}" ]; then
  echo "c4s-unreal-worker: PREFECT_API_URL is not set (the API address of the server that \`c4s up\` names)" >&2
  exit 2
fi
if [ -z "${C4S_STORE:-}" ]; then
  echo "c4s-unreal-worker: C4S_STORE is not set, so ${C4S_HOME:-.c4s} has to be the folder that all machines share" >&2
fi
exec c4s worker --pool engines --slots "${C4S_SLOTS:-1}"
