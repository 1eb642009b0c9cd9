#!/usr/bin/env bash
# Runs a command with a Slurm of its own on this machine, to try what is meant for a cluster:
#   tools/slurm_on_one_machine.sh sbatch --wait --array=0-1 tools/sweep_slurm.sh scenarios/sweeps/short_games.toml
# Needs Debian's slurm-wlm and munge (apt install slurm-wlm munge), and root, as which jobs run then. Everything lies in a
# temporary folder and is gone afterwards; a Slurm that is there already is not touched. No accounting, no control groups.
set -euo pipefail
[ $# -gt 0 ] || { sed -n '2,5s/^# \{0,1\}//p' "$0" >&2; exit 2; }
PATH=$PATH:/usr/sbin
for program in munged slurmctld slurmd sbatch; do
  command -v "$program" >/dev/null || { echo "error: there is no $program here: apt install slurm-wlm munge" >&2; exit 2; }
done
[ "$(id -u)" -eq 0 ] || { echo "error: only root can start slurmd here" >&2; exit 2; }

folder=$(mktemp -d)
chmod 755 "$folder"
pids=()
finish() {
  [ "${#pids[@]}" -eq 0 ] || kill "${pids[@]}" 2>/dev/null || true
  wait
  rm -rf "$folder"
}
trap finish EXIT

mkdir -m 755 "$folder/munge" "$folder/state" "$folder/spool"
(umask 077 && head -c 1024 /dev/urandom >"$folder/munge/key")
munged --foreground --key-file "$folder/munge/key" --socket "$folder/munge/socket" --pid-file "$folder/munge/pid" \
  --log-file "$folder/munge/log" --seed-file "$folder/munge/seed" 2>"$folder/munge/errors" &
pids+=($!)

host=$(hostname -s)
cat >"$folder/slurm.conf" <<END
ClusterName=one_machine
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=26817
SlurmdPort=26818
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
ReturnToService=2
RequeueExit=75
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$folder/slurm.conf

slurmctld -D >/dev/null 2>&1 &
pids+=($!)
slurmd -D >/dev/null 2>&1 &
pids+=($!)
for _ in $(seq 100); do
  [ "$(sinfo --noheader --format %t 2>/dev/null)" = idle ] && break
  sleep 0.2
done
if [ "$(sinfo --noheader --format %t 2>/dev/null)" != idle ]; then
  echo "error: Slurm did not start; the ends of its logs:" >&2
  tail -n 5 "$folder"/munge/errors "$folder"/munge/log "$folder"/*.log >&2 || true
  exit 1
fi
status=0
"$@" || status=$?
exit "$status"
