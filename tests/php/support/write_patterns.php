<?php

declare(strict_types=1);

// Writes patterns of a whole-Moon image of 16-bit samples with the scripts' writer, without a database, for comparison with other writers.
// Arguments: image, product id, px/deg, format, margin in samples, repository. Standard input: a tile a line, as "south west" in degrees.

require dirname(__DIR__) . '/bootstrap.php';

use Msisf\Scripts\Pattern\PatternFormat;
use Msisf\Scripts\Pattern\PatternGenerator;
use Msisf\Scripts\Pattern\PatternRepository;
use Msisf\Scripts\Pattern\TileBatch;
use Msisf\Scripts\Pattern\TileId;
use Msisf\Tests\Support\ImageRadiusSource;

[, $image, $productId, $pixelsPerDegree, $format, $marginSamples, $root] = $argv;
$tiles = [];
while (($line = fgets(STDIN)) !== false) {
    [$south, $west] = array_map('intval', explode(' ', $line));
    $tiles[] = new TileId($south, $west);
}
$repository = new PatternRepository($root, (int) $pixelsPerDegree);
$repository->makeFolder();
$generator = new PatternGenerator(
    new ImageRadiusSource($image, $productId, (int) $pixelsPerDegree),
    $repository,
    PatternFormat::from($format),
    true,
);
foreach (TileBatch::cut($tiles, (int) $pixelsPerDegree, (int) $marginSamples) as $batch) {
    $generator->run($batch);
}
