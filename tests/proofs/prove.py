# SPDX-License-Identifier: MIT
"""Proves the claims of a file (claim.h) for all inputs.

    python3 prove.py FILE.cpp --include FOLDER...

clang translates the file, with the sources that it includes, to LLVM's intermediate
representation, every signed overflow a trap; opt inlines all that a claim calls. symbolic.py makes
obligations of it and z3 refutes their opposites. So what is proven is the code that is compiled,
not a copy of it; clang's front end, opt's inlining and z3 are trusted.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import z3

import ir
import symbolic

PASSES = ("internalize,globaldce,function(sroa,simplifycfg),cgscc(inline),"
          "function(sroa,early-cse,instsimplify,simplifycfg,dce,loop-simplify,lcssa,"
          "loop-rotate,loop(indvars),loop-unroll<O3;full-unroll-max=100>,sroa,early-cse,"
          "instsimplify,simplifycfg,dce),globaldce")


def translated(source, includes, folder):
    """The claims of the file as functions without calls."""
    whole, inlined = folder / "whole.ll", folder / "inlined.ll"
    subprocess.run(
        ["clang++", "-std=c++20", "-O1", "-Xclang", "-disable-llvm-passes", "-fno-exceptions",
         "-fsanitize=signed-integer-overflow,shift,integer-divide-by-zero",
         "-fsanitize-trap=all", *(f"-I{path}" for path in includes), "-S", "-emit-llvm", source,
         "-o", whole], check=True)
    names = re.findall(r"^define [^\n]*@(claim_\w+)\(", whole.read_text(), re.M)
    subprocess.run(
        ["opt", "-S", f"-passes={PASSES}", "-inline-threshold=1000000",
         "-unroll-threshold=100000", f"-internalize-public-api-list={','.join(names)}", whole,
         "-o", inlined], check=True)
    return ir.functions(inlined.read_text(), "claim_")


def simplified(term):
    return z3.simplify(term, som=True, arith_lhs=True, sort_sums=True, blast_distinct=True)


def counter_example(obligation, steps):
    """None where it holds; else the solver's model, or why it gave up. In a context of its own, and
    by the solver's own count of steps, so that neither other obligations nor other work matter."""
    goal = simplified(z3.Not(obligation.holds))
    if z3.is_false(goal):
        return None
    context = z3.Context()
    solver = z3.Solver(ctx=context)
    solver.set("rlimit", steps)
    facts = [simplified(fact) for fact in obligation.rests_on]
    solver.add(*(fact.translate(context) for fact in [*facts, goal]))
    answer = solver.check()
    if answer == z3.unsat:
        return None
    return str(solver.model()) if answer == z3.sat else solver.reason_unknown()


def prove(name, blocks, steps):
    """Prints how the claim fares; is it proven?"""
    begun = time.monotonic()
    walk = symbolic.Walk(blocks, ir.in_order(blocks), ir.successors)
    for obligation in walk.obligations:
        found = counter_example(obligation, steps)
        if found is not None:
            print(f"{name}: NOT PROVEN at {obligation.what}: {found}", flush=True)
            return False
    print(f"{name}: proven, {len(walk.inputs)} inputs, {walk.operations} operations, "
          f"{len(walk.obligations)} obligations left to the solver, {time.monotonic() - begun:.1f} s", flush=True)
    return True


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file", type=pathlib.Path)
    parser.add_argument("--include", action="append", default=[])
    parser.add_argument("--only", default="", help="claims whose names hold this")
    parser.add_argument("--steps", type=int, default=100_000_000,
                        help="of the solver (rlimit) for one obligation, at most")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        claims = translated(options.file, options.include, pathlib.Path(folder))
    if not claims:
        sys.exit(f"{options.file}: no claims")
    chosen = {name: blocks for name, blocks in claims.items() if options.only in name}
    outcomes = [prove(name, blocks, options.steps) for name, blocks in chosen.items()]
    sys.exit(0 if all(outcomes) else 1)


if __name__ == "__main__":
    main()
