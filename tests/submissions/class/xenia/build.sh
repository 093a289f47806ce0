#!/bin/sh
mkdir -p classes
javac -d classes src/raytracer/*.java
