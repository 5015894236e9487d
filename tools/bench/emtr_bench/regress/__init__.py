"""The benchmark that counts instructions, which no other load of the machine disturbs."""
