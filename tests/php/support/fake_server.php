<?php

declare(strict_types=1);

// A server that lets everybody in and answers every query with one text: what a server of another version would say of itself.
// Arguments: path of its socket, the text. It ends with its first client.

[, $path, $text] = $argv;
$listener = stream_socket_server("unix://$path") ?: exit(1);
$client = stream_socket_accept($listener, 30) ?: exit(1);
$send = static fn (int $number, string $body): int|false => fwrite($client, substr(pack('V', strlen($body)), 0, 3) . chr($number) . $body);
$receive = static function () use ($client): string {
    $head = (string) stream_get_contents($client, 4);

    return strlen($head) < 4 ? '' : (string) stream_get_contents($client, unpack('V', substr($head, 0, 3) . "\0")[1]);
};
$ok = "\0\0\0\2\0\0\0";
$column = static fn (string $name): string => chr(strlen($name)) . $name;

// Protocol 10: protocol 4.1, secure connection and plugin authentication; 20 bytes of salt.
$send(0, "\x0a$text\0" . pack('V', 1) . "12345678\0" . pack('v', 0x8208) . "\x2d" . pack('v', 2) . pack('v', 0x0008)
    . chr(21) . str_repeat("\0", 10) . "123456789012\0mysql_native_password\0");
$receive();
$send(2, $ok);
while (($command = $receive()) !== '' && $command[0] === "\x03") {
    if (!str_starts_with(strtoupper(substr($command, 1)), 'SELECT')) {
        $send(1, $ok);
        continue;
    }
    $send(1, "\1");
    $send(2, $column('def') . "\0\0\0" . $column('version') . "\0\x0c" . pack('vVC', 45, 200, 253) . "\0\0\0\0\0");
    $send(3, "\xfe\0\0\2\0");
    $send(4, $column($text));
    $send(5, "\xfe\0\0\2\0");
}
