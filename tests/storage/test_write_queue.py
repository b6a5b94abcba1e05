"""What waits for a disk has an end, and what is lost by that is counted."""

from fleet_tui.storage.write_queue import WriteQueue


def test_the_oldest_are_lost_and_counted() -> None:
    queue = WriteQueue[int](3)
    for number in range(5):
        queue.append(number)
    assert (list(queue), queue.lost) == ([2, 3, 4], 2)


def test_what_could_not_be_written_is_the_next_again_unless_newer_ones_need_its_place() -> None:
    queue = WriteQueue[int](2)
    queue.append(1)
    queue.append(2)
    first = queue.popleft()
    queue.put_back(first)
    assert (list(queue), queue.lost) == ([1, 2], 0)
    first = queue.popleft()
    queue.append(3)
    queue.put_back(first)
    assert (list(queue), queue.lost) == ([2, 3], 1)
