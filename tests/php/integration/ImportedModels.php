<?php

declare(strict_types=1);

namespace Msisf\Tests\Integration;

use Msisf\Scripts\Database\Connection;
use Msisf\Scripts\Database\ConnectionSettings;
use Msisf\Scripts\Database\ImportRecord;
use Msisf\Scripts\Database\ImportRecords;
use Msisf\Scripts\Database\ImportState;
use Msisf\Scripts\Database\Schema;
use Msisf\Scripts\Ldem\Resolution;
use Msisf\Tests\Support\Parts;
use Msisf\Tests\Support\PrivateServer;
use Msisf\Tests\Support\ScriptRun;
use PHPUnit\Framework\Assert;

/** Databases with an elevation model, for the tests of the generation. */
final class ImportedModels
{
    /** @var array<string, string>|null */
    private static ?array $ldem4 = null;

    /** @return array<string, string> the connection to the whole real LDEM_4, imported once a run */
    public static function ldem4(): array
    {
        if (self::$ldem4 === null) {
            $label = (string) preg_replace('/IMG$/', 'LBL', Parts::ldem4Image());
            $environment = PrivateServer::shared()->freshDatabase();
            $run = ScriptRun::start([PHP_BINARY, Parts::root() . '/scripts/ldem_mysql_insert.php', $label], $environment)->wait();
            Assert::assertSame(0, $run->exitCode, $run->errors);
            self::$ldem4 = $environment;
        }

        return self::$ldem4;
    }

    /** @return array<string, string> the connection to a new database with the samples of the tile at 0 N 350 E alone, on a sphere */
    public static function oneTile(): array
    {
        $environment = self::withTables(Resolution::Px4, 'LDEM_4');
        $rows = [];
        for ($row = 340; $row <= 360; $row++) {
            for ($column = 1400; $column <= 1420; $column++) {
                $rows[] = "($row, $column, 0, 0, 1737400, 0, 0, 0, POINT(0, 0))";
            }
        }
        PrivateServer::shared()->execute($environment, 'INSERT INTO ldem_4 VALUES ' . implode(', ', $rows));

        return $environment;
    }

    /** @return array<string, string> the connection to a new database whose record says that all is there, with an empty table */
    public static function withTables(Resolution $resolution, string $productId): array
    {
        $environment = PrivateServer::shared()->freshDatabase();
        $connection = Connection::open(ConnectionSettings::read(null, $environment));
        $connection->useDatabase();
        $schema = new Schema($connection);
        $schema->createImports();
        $schema->createElevations($resolution);
        (new ImportRecords($connection))->add(new ImportRecord(
            $resolution->table(),
            $productId,
            ImportState::Complete,
            Schema::FORMAT_VERSION,
            str_repeat('0', 64),
            str_repeat('0', 64),
            2 * $resolution->lines() * $resolution->lineSamples(),
            0,
            $resolution->lines(),
            0,
            $resolution->lineSamples(),
            $resolution->lines(),
        ));

        return $environment;
    }
}
