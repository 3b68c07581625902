<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Closure;
use Msisf\Scripts\Exception\ExternalPartException;
use PDO;
use PDOException;

/** Turns failures of PDO into messages that say what to do. */
final class DatabaseFailure
{
    /** What to do, by the number of the server's (1000 on) or the client library's (2000 on) error. */
    private const ADVICE = [
        1021 => 'The server\'s disk is full. Make room and run this again: it goes on where it stopped.',
        1028 => 'The server\'s temporary folder is full or not writable. Make room and run this again.',
        1030 => 'The server\'s disk may be full; its error log says more. Mend that and run this again: it goes on where it stopped.',
        1040 => 'Try again later, or raise max_connections.',
        1044 => 'The user lacks rights; docs/database.md lists those that are needed.',
        1045 => 'Check user and password in the option file or in MSISF_DB_USER and MSISF_DB_PASSWORD.',
        1049 => 'Make it with ldem_mysql_insert.php --create, as a user who may.',
        1062 => 'Something else has written to the table: drop it, and import its products again.',
        1114 => 'The server\'s disk or tablespace is full. Make room and run this again: it goes on where it stopped.',
        1142 => 'The user lacks rights; docs/database.md lists those that are needed.',
        1146 => 'Import the elevation model first (ldem_mysql_insert.php).',
        1153 => 'Raise max_allowed_packet of the server to 16 MB or more.',
        1205 => 'Another transaction holds the rows. Run this again: it goes on where it stopped.',
        1213 => 'Another transaction was in the way. Run this again: it goes on where it stopped.',
        1227 => 'The user lacks rights; docs/database.md lists those that are needed.',
        1290 => 'The server runs with an option that forbids it (read-only?).',
        1410 => 'The user lacks rights; docs/database.md lists those that are needed.',
        1698 => 'This user logs in by the socket, not by a password (docs/database.md, In short).',
        2002 => 'Is the server running, and are host, port or socket right?',
        2006 => 'The server has gone away: restart it if it is down, and run this again.',
        2013 => 'The server has gone away: restart it if it is down, and run this again.',
        2054 => 'The server asks for a way to log in that PHP does not have.',
        4031 => 'The server has closed the idle connection. Run this again.',
    ];

    private const ADVICE_OTHER_SERVICE = 'Is it a MySQL or MariaDB server that answers there? Check host and port.';

    private const ADVICE_TLS = 'Does the server have TLS, does its certificate come from the authority in ssl-ca, and does it name the host?';

    /**
     * @template T
     * @param string $server for messages
     * @param Closure(): T $work
     * @return T
     * @throws ExternalPartException PDO failed
     */
    public static function wrap(string $server, Closure $work): mixed
    {
        try {
            return $work();
        } catch (PDOException $exception) {
            throw self::of($exception, $server, self::ADVICE);
        }
    }

    /**
     * @param Closure(): PDO $connect
     * @throws ExternalPartException PDO failed
     */
    public static function wrapConnecting(ConnectionSettings $settings, Closure $connect): PDO
    {
        try {
            return $connect();
        } catch (PDOException $exception) {
            $advice = self::ADVICE;
            if ($settings->tls->pdoOptions() !== []) {
                // Without TLS on the server, PDO hangs up; of a certificate that is refused it says this only.
                $advice[2006] = self::ADVICE_TLS;
                $advice[2002] = str_contains($exception->getMessage(), 'using SSL') ? self::ADVICE_TLS : $advice[2002];
            } elseif ($settings->socket === null) {
                $advice[2006] = self::ADVICE_OTHER_SERVICE;
            }
            throw self::of($exception, $settings->server(), $advice);
        }
    }

    /** The server's error number; 0 if there is none. */
    public static function number(PDOException $exception): int
    {
        // While connecting errorInfo can be missing; the code is then the number itself.
        return (int) ($exception->errorInfo[1] ?? $exception->getCode());
    }

    /** @param array<int, string> $advice by number */
    private static function of(PDOException $exception, string $server, array $advice): ExternalPartException
    {
        $number = self::number($exception);
        // While connecting there can be no errorInfo; the message then begins with "SQLSTATE[HY000] [2002] ".
        $what = $exception->errorInfo[2] ?? (string) preg_replace('/^SQLSTATE\[\w+\]:?(?: \[\d+\])?\s*/', '', $exception->getMessage());
        $hint = $advice[$number] ?? 'The server\'s documentation explains the number.';

        return new ExternalPartException("database $server: " . rtrim($what, '. ') . " (error $number). $hint", $exception);
    }
}
