"""What a function gives back is held against what the host gave."""

from __future__ import annotations

import pytest

from microbrdf_counter.differs import Differs, check

_CALL = {"arguments": [1], "memory": [], "in_memory": False, "results": [7]}


def test_a_register_behind_the_result_may_hold_anything() -> None:
    check("a function", _CALL, [7, 3])


@pytest.mark.parametrize("found", [[8, 3], [], [3, 7]])
def test_another_result_is_told_with_what_it_came_from(found: list[int]) -> None:
    with pytest.raises(Differs, match=r"a function gives .* for \[1\] \[\], the host \[7\]"):
        check("a function", _CALL, found)


def test_every_word_that_the_host_gives_counts() -> None:
    with pytest.raises(Differs):
        check("a function", {**_CALL, "results": [7, 3]}, [7, 4])
