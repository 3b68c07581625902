<?php

declare(strict_types=1);

namespace Msisf\Tests\Integration;

use Msisf\Scripts\Database\Connection;
use Msisf\Scripts\Database\ConnectionSettings;
use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Ldem\Resolution;
use Msisf\Scripts\Pattern\ElevationTable;
use Msisf\Scripts\Pattern\QueryMethod;
use Msisf\Tests\Support\Parts;
use PHPUnit\Framework\TestCase;

/** Both ways to ask for samples give those of the image's file, in its order. */
final class SampleQueryTest extends TestCase
{
    /** @dataProvider rectangles */
    public function testRadiiOfARectangleAreThoseOfTheFile(QueryMethod $method, int $line, int $lines, int $sample, int $samples): void
    {
        $file = (string) file_get_contents(Parts::ldem4Image());
        $expected = [];
        for ($row = $line; $row < $line + $lines; $row++) {
            foreach (unpack('v*', substr($file, 2 * (1440 * $row + $sample), 2 * $samples)) as $value) {
                $expected[] = 1737400.0 + 0.5 * ($value > 32767 ? $value - 65536 : $value);
            }
        }

        self::assertSame($expected, self::table(ImportedModels::ldem4(), $method)->radii($line, $lines, $sample, $samples));
    }

    public static function rectangles(): array
    {
        $places = [
            'one sample' => [0, 1, 0, 1],
            'north-west corner' => [0, 3, 0, 5],
            'south-east corner' => [718, 2, 1430, 10],
            'whole lines' => [359, 2, 0, 1440],
            'a column' => [100, 40, 719, 1],
        ];
        $cases = [];
        foreach ($places as $name => $place) {
            foreach (QueryMethod::cases() as $method) {
                $cases["$name, $method->value"] = [$method, ...$place];
            }
        }

        return $cases;
    }

    public function testRadiiMissingSamplesAreCountedAndNamed(): void
    {
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage(
            'table ldem_4: only 4 of 15 samples of lines 340 to 342, samples 1398 to 1402 are there. Import the product that has them',
        );
        self::table(ImportedModels::oneTile(), QueryMethod::Grid)->radii(339, 3, 1397, 5);
    }

    /** @param array<string, string> $environment the connection */
    private static function table(array $environment, QueryMethod $method): ElevationTable
    {
        $connection = Connection::open(ConnectionSettings::read(null, $environment));
        $connection->useDatabase();

        return ElevationTable::open($connection, Resolution::Px4, $method);
    }
}
