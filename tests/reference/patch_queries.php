<?php

declare(strict_types=1);

// Times the ways of asking for the samples of one patch, beside the thesis's times, for docs/database.md:
//
//     MSISF_DB_...=... php tests/reference/patch_queries.php [resolution]
//
// A patch has 5 x 5 degrees, as in the thesis (table 4.6). Each way gets the same random patches in the same
// run, in turn; medians of the second pass, so everything that fits is in the server's memory. The scan ignores all keys.

use Msisf\Scripts\Database\Connection;
use Msisf\Scripts\Database\ConnectionSettings;
use Msisf\Scripts\Ldem\Resolution;
use Msisf\Scripts\Pattern\GridQuery;
use Msisf\Scripts\Pattern\SampleReader;
use Msisf\Scripts\Pattern\SpatialQuery;
use Msisf\Scripts\Pattern\TileId;
use Msisf\Scripts\Pattern\TileMeshLayout;

require __DIR__ . '/../../scripts/bootstrap.php';

const PATCHES = 20;
const SCANS = 3;
const THESIS_SECONDS = [4 => [0.297, 1.7], 16 => [2.133, 27.4], 64 => [29.3, 451.0]];

$resolution = Resolution::of((int) ($argv[1] ?? 4));
$connection = Connection::open(ConnectionSettings::read(null, getenv()));
$connection->useDatabase();
$scan = static function (int $line, int $lines, int $sample, int $samples) use ($connection, $resolution): array {
    $sql = "SELECT planetary_radius FROM {$resolution->table()} IGNORE INDEX (PRIMARY, point_index)"
        . ' WHERE latitude BETWEEN ? AND ? AND longitude BETWEEN ? AND ?';
    $step = 1.0 / $resolution->value;
    $values = [90.0 - ($line + $lines) * $step, 90.0 - $line * $step, $sample * $step, ($sample + $samples) * $step];

    return SampleReader::fetch($connection, $sql, $values, PDO::FETCH_COLUMN);
};
$ways = [
    'grid' => (new GridQuery($connection, $resolution))->radii(...),
    'spatial' => (new SpatialQuery($connection, $resolution))->radii(...),
    'scan' => $scan,
];
mt_srand(20120222);
$milliseconds = array_fill_keys(array_keys($ways), []);
for ($i = 0; $i < PATCHES; $i++) {
    // Away from seam and poles: every patch has the same number of samples.
    $tile = new TileId(5 * mt_rand(-16, 15), 5 * mt_rand(1, 70));
    $layout = TileMeshLayout::for($tile, $resolution->value, 0);
    foreach ($ways as $name => $way) {
        if ($name === 'scan' && $i >= SCANS) {
            continue;
        }
        $way($layout->firstLine, $layout->lines, $layout->firstSample, $layout->samples);
        $start = hrtime(true);
        $radii = $way($layout->firstLine, $layout->lines, $layout->firstSample, $layout->samples);
        $milliseconds[$name][] = (hrtime(true) - $start) / 1e6;
        if (count($radii) !== $layout->lines * $layout->samples) {
            throw new LogicException("$name: " . count($radii) . ' samples');
        }
    }
}
$median = static function (array $numbers): float {
    sort($numbers);

    return $numbers[intdiv(count($numbers), 2)];
};
[$indexed, $plain] = THESIS_SECONDS[$resolution->value] ?? [NAN, NAN];
printf("LDEM_%d, %d samples a patch, %s\n", $resolution->value, $layout->lines * $layout->samples, $connection->serverVersion);
foreach ($milliseconds as $name => $times) {
    $thesis = $name === 'scan' ? $plain : $indexed;
    printf(
        "%-8s %10.2f ms  1 : %-8.1f of the scan  thesis %8.3f s (1 : %.0f)\n",
        $name,
        $median($times),
        $median($milliseconds['scan']) / $median($times),
        $thesis,
        1000 * $thesis / $median($times),
    );
}
