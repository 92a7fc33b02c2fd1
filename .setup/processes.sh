#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# processes.sh N FREEFEM SCRIPT...: FREEFEM -mpi on N processes, which share the processors of this machine.
set -eu
processes=$1 freefem=$2
shift 2
threads=$(($(nproc) / processes))
export OMP_NUM_THREADS="${OMP_NUM_THREADS-$((threads > 0 ? threads : 1))}"
# One machine: messages in shared memory, without what a container forbids, no ssh, and no word of mpirun's own on how a
# script ended (OpenMPI 5, whose mpirun is PRRTE's, says it all the same).
export OMPI_MCA_btl="${OMPI_MCA_btl-self,vader}" OMPI_MCA_plm_rsh_agent="${OMPI_MCA_plm_rsh_agent-sh}"
export OMPI_MCA_orte_execute_quiet=1 PRTE_MCA_plm_ssh_agent="${PRTE_MCA_plm_ssh_agent-sh}"
export OMPI_MCA_btl_vader_single_copy_mechanism="${OMPI_MCA_btl_vader_single_copy_mechanism-none}"
if [ "$(id -u)" = 0 ]; then export {OMPI,PRTE}_ALLOW_RUN_AS_ROOT=1 {OMPI,PRTE}_ALLOW_RUN_AS_ROOT_CONFIRM=1; fi
exec mpirun --oversubscribe -np "$processes" "$freefem" -mpi "$@"
