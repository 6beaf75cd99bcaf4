module carom

go 1.24
