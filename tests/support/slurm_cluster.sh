#!/usr/bin/env bash
# Slurm cluster for tests, with two nodes n1 and n2 of one core each, on the loopback interface. It needs root. All files
# are in DIR. Set SLURM_CONF=DIR/slurm.conf to use the Slurm tools.
#   slurm_cluster.sh start DIR            starts the cluster and returns when both nodes are idle; the cluster stops
#                                         when the calling process ends
#   slurm_cluster.sh stop DIR             stops the cluster and its jobs
#   slurm_cluster.sh kill-node DIR NODE   kills a node with all its processes, like a power failure
set -euo pipefail
mkdir -p "$2"
dir=$(cd "$2" && pwd)
export SLURM_CONF=$dir/slurm.conf

# Prints N unused ports.
free_ports() {
  local port=$((20000 + RANDOM % 30000)) wanted=$1
  while [ "$wanted" -gt 0 ]; do
    port=$((port + 1))
    (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null && continue
    echo "$port"
    wanted=$((wanted - 1))
  done
}

write_conf() {
  local host ports
  host=$(hostname -s)
  mapfile -t ports < <(free_ports 3)
  cat >"$SLURM_CONF" <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=${ports[0]}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$dir/munge.socket,cred_expire=5
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
StateSaveLocation=$dir/state
SlurmctldPidFile=$dir/slurmctld.pid
SlurmctldLogFile=$dir/slurmctld.log
SlurmdSpoolDir=$dir/spool_%n
SlurmdPidFile=$dir/%n.pid
SlurmdLogFile=$dir/%n.log
SlurmdParameters=config_overrides
MaxArraySize=11
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,bf_interval=1
ReturnToService=2
SlurmdTimeout=5
KillWait=2
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=${ports[1]} CPUs=1 RealMemory=1000
NodeName=n2 NodeHostname=$host NodeAddr=127.0.0.1 Port=${ports[2]} CPUs=1 RealMemory=1000
PartitionName=all Nodes=n1,n2 Default=YES State=UP
CONF
}

wait_until() {
  for _ in $(seq 400); do
    if "$@" 2>/dev/null; then return; fi
    sleep 0.1
  done
  echo "slurm_cluster.sh: timeout: $*" >&2
  tail --lines=5 "$dir"/*.log >&2
  exit 1
}
both_idle() { [ "$(sinfo --noheader --Node --states=idle --format=%N | wc -l)" = 2 ]; }

start() {
  mkdir -p "$dir/state"
  chmod 755 "$dir"
  write_conf
  (umask 077 && head -c 1024 /dev/urandom >"$dir/munge.key")
  munged --force --socket="$dir/munge.socket" --key-file="$dir/munge.key" --pid-file="$dir/munged.pid" \
    --log-file="$dir/munged.log" --seed-file="$dir/munge.seed"
  slurmctld -f "$SLURM_CONF"
  slurmd -f "$SLURM_CONF" -N n1
  slurmd -f "$SLURM_CONF" -N n2
  wait_until both_idle
}

# Prints the processes of a node: the slurmstepd processes, then those of the jobs.
processes_of() {
  local pid parent steps="" jobs=""
  for environ in /proc/[0-9]*/environ; do
    grep -qszx "SLURM_CONF=$SLURM_CONF" "$environ" && grep -qszx "SLURMD_NODENAME=$1" "$environ" || continue
    pid=$(basename "$(dirname "$environ")")
    jobs+=" $pid"
    parent=$(awk '/^PPid:/ {print $2}' "/proc/$pid/status" 2>/dev/null) || continue
    grep -qs slurmstepd "/proc/$parent/comm" && steps+=" $parent"
  done
  echo "$steps $jobs"
}

end_processes_of() {
  local pid
  for pid in $(processes_of "$1"); do kill -9 "$pid" 2>/dev/null || true; done
}

kill_node() {
  kill -9 "$(cat "$dir/$1.pid")"
  end_processes_of "$1"
}

# A process that has ended is listed as a zombie until its parent waits for it.
ended() { ! grep -qs '^State:[[:space:]]*[^ZX]' "/proc/$1/status"; }

stop() {
  local daemon pid
  end_processes_of n1
  end_processes_of n2
  for daemon in n1 n2 slurmctld munged; do
    pid=$(cat "$dir/$daemon.pid" 2>/dev/null) || continue
    kill "$pid" 2>/dev/null || continue
    wait_until ended "$pid"
  done
}

stop_with_caller() {
  while kill -0 "$PPID" 2>/dev/null; do sleep 1; done
  stop
}

case $1 in
  start)
    stop_with_caller </dev/null >/dev/null 2>&1 &
    start
    ;;
  stop) stop ;;
  kill-node) kill_node "$3" ;;
  *) exit 2 ;;
esac
