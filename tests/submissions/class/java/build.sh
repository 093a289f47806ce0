#!/bin/sh
# builds the classes
set -e
mkdir -p classes
javac -d classes src/rt/*.java
