"""The situation: facts about robots and links, decided once; alarms and reasons read them. Pure."""
