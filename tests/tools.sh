#!/bin/sh
# Make sure that a command is there: tools.sh COMMAND DEBIAN-PACKAGE...
# Installs the Debian packages where it may; else says that the tests that need them are skipped,
# which under CI is a failure.
command=$1
shift
command -v "$command" >/dev/null && exit 0
if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    echo "Installing $* for the tests"
    export DEBIAN_FRONTEND=noninteractive
    apt-get update -qq && apt-get install -y -qq --no-install-recommends "$@" >/dev/null
    command -v "$command" >/dev/null && exit 0
fi
echo "SKIPPED: the tests that need $command (Debian packages: $*)"
[ -z "$CI" ]
