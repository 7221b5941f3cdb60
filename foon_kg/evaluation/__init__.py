"""How good the trees are: the paper's experiment with an executable rule, and videos left out one by one.

The paper (section on experiments) had people score each progress line 0, 1 or 2; here :mod:`~foon_kg.evaluation.scores`
does, and :mod:`~foon_kg.evaluation.sheet` lets people do it too. The paper names leave-one-out as future work;
:mod:`~foon_kg.evaluation.leave_one_out` does that.

Whether people accept whole trees is another question: :mod:`~foon_kg.evaluation.reading` draws trees for them.
"""
