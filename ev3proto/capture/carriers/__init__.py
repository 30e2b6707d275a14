"""What carries frames: from packets to pieces of byte streams, USB reports and datagrams."""
