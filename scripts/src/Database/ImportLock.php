<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Closure;
use Msisf\Scripts\Exception\ExternalPartException;
use Msisf\Scripts\Ldem\Resolution;

/** One import at a time into a table. The server gives the lock back when the connection ends, however it ends. */
final class ImportLock
{
    /**
     * @param int $patienceSeconds how long to wait for another import
     * @param Closure(string): void $tell is told when it has to wait
     * @throws ExternalPartException the other import takes longer
     */
    public static function take(Connection $connection, Resolution $resolution, int $patienceSeconds, Closure $tell): void
    {
        // Locks are the server's, not the database's; their names have 64 characters at most.
        $name = 'msisf.' . substr(hash('sha256', "$connection->database.{$resolution->table()}"), 0, 40);
        if ($connection->value('SELECT GET_LOCK(?, 0)', [$name]) === 1) {
            return;
        }
        $where = "{$resolution->table()} in the database $connection->database";
        if ($patienceSeconds > 0) {
            $tell("another import into $where is running; waiting up to $patienceSeconds s for it");
        }
        if ($patienceSeconds === 0 || $connection->value('SELECT GET_LOCK(?, ?)', [$name, $patienceSeconds]) !== 1) {
            throw ExternalPartException::database(
                "another import into $where is running. Wait until it has ended, or give a longer --wait.",
            );
        }
    }
}
