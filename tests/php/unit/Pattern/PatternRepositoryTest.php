<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Pattern;

use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Exception\ExternalPartException;
use Msisf\Scripts\Pattern\PatternRepository;
use Msisf\Scripts\Pattern\TileId;
use Msisf\Tests\Support\TemporaryFolder;
use PHPUnit\Framework\TestCase;

final class PatternRepositoryTest extends TestCase
{
    private const HEADER = '// msisf-pattern 1 format=mesh2 product=LDEM_4 bytes=';
    private const GOOD = self::HEADER . "000000000070\nmesh";

    private TemporaryFolder $folder;
    private PatternRepository $repository;
    private TileId $tile;

    protected function setUp(): void
    {
        $this->folder = new TemporaryFolder();
        $this->repository = new PatternRepository($this->folder->path('[r*]') . '/', 4);
        $this->repository->makeFolder();
        $this->tile = new TileId(-5, 355);
    }

    public function testPathOfIsThatOfMsis(): void
    {
        self::assertSame(
            $this->folder->path('[r*]/4/pattern_LDEM_4_lat_-5_0_lon_355_360.inc'),
            $this->repository->pathOf($this->tile),
        );
    }

    /** @dataProvider contents */
    public function testNeedsLooksAtHeaderAndLength(?string $content, bool $expected): void
    {
        if ($content !== null) {
            file_put_contents($this->repository->pathOf($this->tile), $content);
        }

        self::assertSame($expected, $this->repository->needs($this->tile, self::HEADER));
    }

    public static function contents(): array
    {
        return [
            'missing' => [null, true],
            'good' => [self::GOOD, false],
            'cut off' => [substr(self::GOOD, 0, -1), true],
            'cut off in the header' => [substr(self::GOOD, 0, 8), true],
            'longer' => [self::GOOD . 'x', true],
            'another model' => [str_replace('LDEM_4', 'LDEM_5', self::GOOD), true],
            'another length' => [str_replace('070', '071', self::GOOD), true],
            'empty after a power cut' => ['', true],
            'zeros after a power cut' => [str_repeat("\0", 70), true],
        ];
    }

    public function testNeedsForeignFileIsRefusedAndStays(): void
    {
        $path = $this->repository->pathOf($this->tile);
        file_put_contents($path, '// my own mesh');
        try {
            $this->repository->needs($this->tile, self::HEADER);
            self::fail('The foreign file was not noticed.');
        } catch (BadInputException $exception) {
            self::assertStringContainsString($path, $exception->getMessage());
        }
        self::assertStringEqualsFile($path, '// my own mesh');
    }

    public function testNeedsFolderUnderThePatternsNameIsRefused(): void
    {
        mkdir($this->repository->pathOf($this->tile));
        $this->expectException(ExternalPartException::class);
        $this->repository->needs($this->tile, self::HEADER);
    }

    public function testMakeFolderWhereAFileStandsIsRefused(): void
    {
        file_put_contents($this->folder->path('file'), '');
        $this->expectException(ExternalPartException::class);
        $this->expectExceptionMessage('--repository');
        (new PatternRepository($this->folder->path('file'), 4))->makeFolder();
    }

    public function testRemoveStaleFilesRemovesOnlyOldPartials(): void
    {
        $hours = static fn (float $ago): int => (int) (1_700_000_000 - 3600 * $ago);
        $ages = [
            'pattern_a.inc' => 5.0,
            'pattern_b.1-ab.partial.inc' => 1.1,
            'pattern_c.1-ab.partial.inc' => 0.9,
            'pattern_d.inc' => 0.0,
            'other.partial.inc' => 5.0,
        ];
        foreach ($ages as $name => $ago) {
            touch($this->repository->folder() . "/$name", $hours($ago));
        }

        $this->repository->removeStaleFiles();

        self::assertSame(
            ['other.partial.inc', 'pattern_a.inc', 'pattern_c.1-ab.partial.inc', 'pattern_d.inc'],
            array_values(array_diff(scandir($this->repository->folder()), ['.', '..'])),
        );
    }
}
