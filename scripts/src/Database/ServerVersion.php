<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Msisf\Scripts\Exception\ExternalPartException;

/** Which server answers, from SELECT VERSION(). */
final class ServerVersion
{
    private const LEAST_MARIADB = '10.5';

    /** Before 8.0 a POINT column can't have the SRID attribute, without which MySQL 8 does not use a spatial index. */
    private const LEAST_MYSQL = '8.0';

    private function __construct(public readonly bool $isMariaDb, public readonly string $number)
    {
    }

    /**
     * @param string $text e.g. "10.11.19-MariaDB-0+deb12u1", "8.0.36", "5.5.5-10.6.1-MariaDB"
     * @throws ExternalPartException the server is too old or unknown
     */
    public static function parse(string $text): self
    {
        // Old MariaDB servers put 5.5.5- before their version for the sake of old MySQL clients.
        if (preg_match('/^(?:5\.5\.5-)?([0-9]+\.[0-9]+\.[0-9]+)([^0-9].*)?$/Ds', $text, $parts) !== 1) {
            $shown = substr(addcslashes($text, "\0..\37"), 0, 60);
            throw ExternalPartException::database("the server says that its version is '$shown'; " . self::need());
        }
        $isMariaDb = stripos($parts[2] ?? '', 'mariadb') !== false;
        $least = $isMariaDb ? self::LEAST_MARIADB : self::LEAST_MYSQL;
        if (version_compare($parts[1], $least, '<')) {
            throw ExternalPartException::database(($isMariaDb ? 'MariaDB' : 'MySQL') . " $parts[1] is too old; " . self::need());
        }

        return new self($isMariaDb, $parts[1]);
    }

    public function __toString(): string
    {
        return ($this->isMariaDb ? 'MariaDB ' : 'MySQL ') . $this->number;
    }

    private static function need(): string
    {
        return 'MariaDB ' . self::LEAST_MARIADB . ' or MySQL ' . self::LEAST_MYSQL . ', or later, is needed. Update the server.';
    }
}
