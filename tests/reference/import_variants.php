<?php

declare(strict_types=1);

// Seconds of several ways to import LDEM_4, in one run, for docs/database.md. The database of the connection is written to:
//     MSISF_DB_SOCKET=... MSISF_DB_USER=... php tests/reference/import_variants.php input/ldem/LDEM_4.LBL
// The thesis's way: its final table (listing 4.1, MyISAM), one INSERT of text a line of the image (appendix B.3).

use Msisf\Scripts\Console\Output;
use Msisf\Scripts\Database\Connection;
use Msisf\Scripts\Database\ConnectionSettings;
use Msisf\Scripts\Database\GridTables;
use Msisf\Scripts\Database\LdemImporter;
use Msisf\Scripts\Database\LoaderChoice;
use Msisf\Scripts\Database\LocalFileLoader;
use Msisf\Scripts\Database\RowText;
use Msisf\Scripts\Database\Schema;
use Msisf\Scripts\Ldem\LdemImage;
use Msisf\Scripts\Ldem\LdemLabelReader;
use Msisf\Scripts\Ldem\Resolution;

require __DIR__ . '/../../scripts/bootstrap.php';

const SAMPLE_ROWS = 5000;

$image = LdemImage::open(LdemLabelReader::readFile($argv[1]));
$resolution = Resolution::of($image->label->pixelsPerDegree);
$connection = Connection::open(ConnectionSettings::read(null, getenv()), true);
$connection->useDatabase();
$clear = static function () use ($connection, $resolution): void {
    $connection->execute("DROP TABLE IF EXISTS thesis, {$resolution->table()}, ldem_import");
};
$thesisTable = static function (string $engine) use ($connection): void {
    $connection->execute('CREATE TABLE thesis (point_id BIGINT UNSIGNED NOT NULL AUTO_INCREMENT, lat DOUBLE NOT NULL, lon DOUBLE NOT NULL,'
        . ' planetary_radius DOUBLE NOT NULL, x DOUBLE, y DOUBLE, z DOUBLE, `point` POINT NOT NULL /*!80003 SRID 0 */,'
        . " PRIMARY KEY (point_id), SPATIAL KEY point_index (`point`)) ENGINE=$engine");
};
$numbers = static function (int $line, int $sample, int|float $value) use ($image): array {
    $latitude = 90 - ($line + 0.5) / $image->label->pixelsPerDegree;
    $longitude = ($sample + 0.5) / $image->label->pixelsPerDegree;
    $radius = $image->radius($value);
    $equatorial = $radius * cos(deg2rad($latitude));

    return [$latitude, $longitude, $radius, $equatorial * cos(deg2rad($longitude)), $equatorial * sin(deg2rad($longitude)), $radius * sin(deg2rad($latitude))];
};
$import = static fn (LoaderChoice $way) => (new LdemImporter($connection, new Output('variants', fopen('php://memory', 'w'), fopen('php://memory', 'w')), $way->loader(...)))
    ->import($image, false, 0);

/** @var array<string, Closure(): float> $variants each returns by how much its time is multiplied: it may do a part only */
$variants = [
    'LOAD DATA LOCAL' => static function () use ($import): float {
        $import(LoaderChoice::LocalFile);

        return 1.0;
    },
    'INSERT of 5000 rows' => static function () use ($import): float {
        $import(LoaderChoice::Insert);

        return 1.0;
    },
    'LOAD DATA LOCAL, no spatial index' => static function () use ($connection, $image, $resolution): float {
        (new Schema($connection))->createElevations($resolution);
        $connection->execute("ALTER TABLE {$resolution->table()} DROP KEY point_index");
        $grid = new GridTables($connection, $resolution, $image->label);
        $grid->create();
        $loader = new LocalFileLoader($connection);
        $text = new RowText($image);
        $band = [];
        foreach ($image->lines() as $line => $values) {
            $band[$line] = $values;
            if (count($band) === 40 || $line + 1 === $image->label->lines) {
                array_map($loader->load(...), iterator_to_array($text->chunks($band), false));
                $connection->inTransaction($grid->insertElevations(...));
                $grid->clearRadii();
                $band = [];
            }
        }

        return 1.0;
    },
    'thesis: MyISAM, one INSERT of text a line' => static function () use ($connection, $image, $thesisTable, $numbers): float {
        $thesisTable('MyISAM');
        foreach ($image->lines() as $line => $values) {
            $rows = [];
            foreach ($values as $sample => $value) {
                $n = $numbers($line, $sample, $value);
                $rows[] = "(NULL,'" . implode("','", $n) . "',POINT($n[0],$n[1]))";
            }
            $connection->execute('INSERT INTO thesis VALUES ' . implode(',', $rows));
        }

        return 1.0;
    },
    'InnoDB, row by row (' . SAMPLE_ROWS . ' rows, extrapolated)' => static function () use ($connection, $image, $thesisTable, $numbers): float {
        $thesisTable('InnoDB');
        $insert = $connection->prepare('INSERT INTO thesis VALUES (NULL, ?, ?, ?, ?, ?, ?, POINT(?, ?))');
        $done = 0;
        foreach ($image->lines() as $line => $values) {
            foreach ($values as $sample => $value) {
                $n = $numbers($line, $sample, $value);
                $insert->execute([...$n, $n[0], $n[1]]);
                if (++$done === SAMPLE_ROWS) {
                    return $image->label->lines * $image->label->lineSamples / SAMPLE_ROWS;
                }
            }
        }

        return 1.0;
    },
];

$first = null;
foreach ($variants as $name => $variant) {
    $clear();
    $connection->value('SELECT RELEASE_ALL_LOCKS()');
    $start = hrtime(true);
    $factor = $variant();
    $seconds = $factor * (hrtime(true) - $start) / 1e9;
    $first ??= $seconds;
    printf("%-50s %8.1f s  %6.2f\n", $name, $seconds, $seconds / $first);
}
$clear();
