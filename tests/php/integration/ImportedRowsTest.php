<?php

declare(strict_types=1);

namespace Msisf\Tests\Integration;

use Msisf\Scripts\Numerics\DegreeTrigonometry;
use Msisf\Tests\Support\LabelText;
use Msisf\Tests\Support\Parts;
use Msisf\Tests\Support\PrivateServer;
use Msisf\Tests\Support\ScriptRun;
use Msisf\Tests\Support\TestLength;
use PDO;

final class ImportedRowsTest extends ImportTestCase
{
    /** Of so many lines the last one is compared; all with MSISF_LONG_TESTS=1. */
    private const STEP = 5;

    /** Read with unpack and the label's three numbers alone: nothing of the importer's own reading. */
    public function testImportRealLdem4RowsAreTheFiles(): void
    {
        $environment = ImportedModels::ldem4();
        $values = unpack('v*', (string) file_get_contents(Parts::ldem4Image()));
        $pdo = new PDO("mysql:unix_socket=$environment[MSISF_DB_SOCKET];dbname=$environment[MSISF_DB_DATABASE]", 'root', '', [
            PDO::ATTR_EMULATE_PREPARES => false, PDO::MYSQL_ATTR_USE_BUFFERED_QUERY => false,
        ]);
        $select = $pdo->prepare('SELECT row_index, col_index, latitude, longitude, planetary_radius, x, y, z, ST_X(`point`), ST_Y(`point`)'
            . ' FROM ldem_4 WHERE MOD(row_index, ?) = ? ORDER BY row_index, col_index');
        $step = TestLength::of(self::STEP, 1);
        $select->execute([$step, $step - 1]);
        $longitudes = [];
        for ($column = 0; $column < 1440; $column++) {
            $longitudes[] = [DegreeTrigonometry::sin(2 * $column + 1, 8), DegreeTrigonometry::cos(2 * $column + 1, 8)];
        }
        $rows = 0;
        while (($found = $select->fetch(PDO::FETCH_NUM)) !== false) {
            $row = $step * intdiv($rows, 1440) + $step - 1;
            $column = $rows % 1440;
            if ($column === 0) {
                $sine = DegreeTrigonometry::sin(719 - 2 * $row, 8);
                $cosine = DegreeTrigonometry::cos(719 - 2 * $row, 8);
            }
            $rows++;
            $value = $values[1440 * $row + $column + 1];
            $radius = 1737400.0 + 0.5 * ($value > 32767 ? $value - 65536 : $value);
            $latitude = 89.875 - $row / 4;
            $longitude = 0.125 + $column / 4;
            $expected = [
                $row, $column, $latitude, $longitude, $radius, $radius * $cosine * $longitudes[$column][1],
                $radius * $cosine * $longitudes[$column][0], $radius * $sine, $longitude, $latitude,
            ];
            if ($found !== $expected) {
                self::assertSame($expected, $found);
            }
        }
        self::assertSame(intdiv(1036800, $step), $rows);
        self::assertSame(1036800, PrivateServer::shared()->value($environment, 'SELECT COUNT(*) FROM ldem_4'));
    }

    /** By docs/pattern-format.md, section 8: the first vertex of the tile 0 to 5 N, 0 to 5 E is this lattice point. */
    public function testImportRealLdem4FirstVertexOfTheFormatsExampleIsMet(): void
    {
        $sql = 'SELECT CONCAT_WS(\',\', FLOOR(128 * x + 0.5), FLOOR(128 * y + 0.5), FLOOR(128 * z + 0.5)) FROM ldem_4 WHERE row_index = 340 AND col_index = 0';
        self::assertSame('221464209,483161,18888887', PrivateServer::shared()->value(ImportedModels::ldem4(), $sql));
    }

    public function testImportRealLdem4SpatialIndexFindsThePatch(): void
    {
        $where = "MBRContains(ST_GeomFromText('POLYGON((10 25, 15 25, 15 30, 10 30, 10 25))'), `point`)";
        $server = PrivateServer::shared();
        self::assertSame(400, $server->value(ImportedModels::ldem4(), "SELECT COUNT(*) FROM ldem_4 WHERE $where"));
        $plan = (string) $server->value(ImportedModels::ldem4(), "EXPLAIN FORMAT=JSON SELECT * FROM ldem_4 WHERE $where");
        self::assertStringContainsString('"key": "point_index"', $plan);
    }

    public function testImportBothBulkWaysGiveTheSameRows(): void
    {
        $label = $this->smallProduct();
        $run = $this->import(['--load=local-file', $label]);
        self::assertDone($run);
        self::assertSame("ldem_4 SMALL 800 rows\n", $run->output);
        self::assertStringContainsString('by LOAD DATA LOCAL', $run->errors);
        $byFile = $this->checksum();
        $this->execute('DROP TABLE ldem_4, ldem_import');
        $run = $this->import(['--load=insert', $label]);
        self::assertDone($run);
        self::assertStringContainsString('by INSERT of 5000 rows', $run->errors);
        self::assertSame($byFile, $this->checksum());
        self::assertStringStartsWith('800 ', $byFile);
    }

    public function testImportFloatsArriveBitForBit(): void
    {
        $samples = '';
        for ($i = 0; $i < 800; $i++) {
            $samples .= pack('G', 0.001 * (($i * 7919) % 20011) - 9.87654321);
        }
        $label = LabelText::writeProduct($this->folder, 'FLOATS', [-85, -90, 350, 360], $samples, [
            'SAMPLE_TYPE' => 'IEEE_REAL', 'SAMPLE_BITS' => '32', 'UNIT' => 'KILOMETER', 'SCALING_FACTOR' => '1.0',
            'OFFSET' => '1737.4', 'MINIMUM' => '-9.88', 'MAXIMUM' => '10.14',
        ]);
        self::assertDone($this->import([$label]));
        self::assertSame(
            1737400.0 + 1000.0 * unpack('G', $samples, 4 * 799)[1],
            $this->value('SELECT planetary_radius FROM ldem_4 WHERE row_index = 719 AND col_index = 1439'),
        );
        self::assertDone($this->import(['--verify', $label]));
    }

    public function testImportPartialProductsFillOneTable(): void
    {
        $labels = [
            LabelText::writeProduct($this->folder, 'LDEM_4_00N_05N_000_010', [5, 0, 0, 10], LabelText::samples(800, 2)),
            LabelText::writeProduct($this->folder, 'LDEM_4_05S_00N_350_360', [0, -5, 350, 360], LabelText::samples(800, 3)),
        ];
        $run = $this->import($labels);
        self::assertDone($run);
        self::assertSame("ldem_4 LDEM_4_00N_05N_000_010 800 rows\nldem_4 LDEM_4_05S_00N_350_360 800 rows\n", $run->output);
        self::assertSame(
            '340 379 0 1439 1600',
            $this->value('SELECT CONCAT_WS(\' \', MIN(row_index), MAX(row_index), MIN(col_index), MAX(col_index), COUNT(*)) FROM ldem_4'),
        );
        self::assertDone($this->import(['--verify', ...$labels]));
    }

    public function testImportSettingsOfPhpDoNotMatter(): void
    {
        $script = Parts::root() . '/scripts/ldem_mysql_insert.php';
        $settings = ['precision=3', 'serialize_precision=3', 'memory_limit=16M', 'display_errors=1', 'error_reporting=0', 'output_buffering=4096'];
        $options = array_merge(...array_map(static fn (string $setting): array => ['-d', $setting], $settings));
        $run = ScriptRun::start([PHP_BINARY, ...$options, $script, $this->smallProduct()], $this->environment)->wait();
        self::assertDone($run);
        self::assertDone($this->import(['--verify', $this->smallProduct()]));
    }
}
