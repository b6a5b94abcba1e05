"""Words that find a key, besides its own."""

from fleet_tui.keys import BY_ID
from fleet_tui.ui.view.help.synonyms import SYNONYMS


def test_they_belong_to_keys_and_say_what_the_keys_do_not() -> None:
    assert set(SYNONYMS) <= set(BY_ID)
    own = {id_: set(BY_ID[id_].text.casefold().replace(":", "").split()) for id_ in SYNONYMS}
    assert {id_: own[id_] & set(words.split()) for id_, words in SYNONYMS.items()} == {
        id_: set() for id_ in SYNONYMS
    }


def test_the_search_in_lower_case_finds_each() -> None:
    assert [words for words in SYNONYMS.values() if words != words.casefold()] == []
