message SYSTEM_COMMAND_REPLY 7
LIST_FILES max_bytes=1000 path="../prjs/"
