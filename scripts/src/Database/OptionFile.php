<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Msisf\Scripts\Exception\BadInputException;

/** Reads the [client] group of an option file of the MySQL and MariaDB clients. A message never shows a value. */
final class OptionFile
{
    /** Options that are read; in a file, "_" in a name is "-". */
    public const KNOWN = ['host', 'port', 'socket', 'user', 'password', 'database', ...self::TLS];

    private const TLS = ['ssl-ca', 'ssl-mode', 'ssl-verify-server-cert'];

    /** Others that change the connection: to leave one out unread could mean another server, or one that is not verified. */
    private const OF_CONNECTION = '/^protocol$|(?:^|-)(?:ssl|tls)(?:-|$)/Di';

    private const ESCAPES = ['b' => "\x08", 't' => "\t", 'n' => "\n", 'r' => "\r", '\\' => '\\', 's' => ' ', '"' => '"', "'" => "'"];

    /**
     * @return array<string, string> by the names of KNOWN
     * @throws BadInputException the file can't be read, others can read its password, a line is no option, or an option would
     *                           change the connection in a way that is not supported
     */
    public static function read(string $path): array
    {
        $text = is_file($path) ? @file_get_contents($path) : false;
        if ($text === false) {
            throw BadInputException::inFile($path, 'this option file is missing or can\'t be read.');
        }
        $values = self::parse($text, $path);
        if (isset($values['password']) && DIRECTORY_SEPARATOR === '/' && (fileperms($path) & 0o077) !== 0) {
            throw BadInputException::inFile($path, 'holds a password, and other users may read it. Say: chmod 600 on it.');
        }

        return $values;
    }

    /** @return array<string, string> */
    private static function parse(string $text, string $path): array
    {
        $values = [];
        $isClient = false;
        foreach (preg_split('/\r\n|\n|\r/', $text) ?: [] as $index => $line) {
            $line = trim($line);
            if ($line === '' || $line[0] === '#' || $line[0] === ';') {
                continue;
            }
            if (preg_match('/^\[([^\]]+)\]$/', $line, $group) === 1) {
                $isClient = $group[1] === 'client';
            } elseif ($line[0] === '!' || preg_match('/^([0-9A-Za-z_-]+)\s*(?:=\s*(.*))?$/s', $line, $option) !== 1) {
                throw BadInputException::atLine(
                    $path,
                    $index + 1,
                    'neither [group] nor name=value. Keep the connection in a file of its own, without !include.'
                );
            } elseif ($isClient) {
                $name = strtr($option[1], '_', '-');
                if (in_array($name, self::KNOWN, true)) {
                    $values[$name] = self::unquoted($option[2] ?? '');
                } elseif (preg_match(self::OF_CONNECTION, $name) === 1) {
                    throw BadInputException::atLine($path, $index + 1, "the option $name is not supported here. "
                        . 'Leave it out; host, port, socket, ' . implode(', ', self::TLS) . ' say how to connect.');
                }
            }
        }

        return $values;
    }

    /** The rules of the clients: quotes round a value are left out, " #" begins a comment outside them, backslashes escape. */
    private static function unquoted(string $value): string
    {
        if (preg_match('/^(["\'])((?:\\\\.|(?!\1)[^\\\\])*)\1(?:\s*#.*)?$/s', $value, $quoted) === 1) {
            $value = $quoted[2];
        } else {
            $value = rtrim((string) preg_replace('/\s#.*$/s', '', $value));
        }

        return (string) preg_replace_callback(
            '/\\\\([btnr\\\\s"\'])/',
            static fn (array $match): string => self::ESCAPES[$match[1]],
            $value
        );
    }
}
