<?php

declare(strict_types=1);

namespace Msisf\Tests\Integration;

use Msisf\Tests\Support\Parts;
use Msisf\Tests\Support\PrivateServer;
use Msisf\Tests\Support\ReferencePatterns;
use Msisf\Tests\Support\ScriptRun;

/** The patterns from the database are those that msis makes from the image, byte for byte. */
final class SamePatternsTest extends GenerationTestCase
{
    /**
     * Two processes with the grid's query: testSceneOfSection92FromPatternsOfTheDatabaseIsTheSameImage.
     *
     * @dataProvider ways
     */
    public function testAllTilesOfTheRealMoonAreThoseOfMsis(array $arguments): void
    {
        $repository = $this->folder->path('repository');

        $run = $this->generate(['--all', '--repository', $repository, ...$arguments]);

        self::assertSame([0, "$repository/4\n"], [$run->exitCode, $run->output], $run->errors);
        self::assertMatchesRegularExpression(
            '/2592 patterns made, 0 were there, in [0-9.]+ s: database [0-9.]+ s \(\d+ %\), PHP .* writing /',
            $run->errors,
        );
        self::assertAllPatternsOfMsis($repository);
    }

    public static function ways(): array
    {
        return [
            'grid' => [[]],
            'spatial, two processes' => [['--jobs', '2', '--query', 'spatial']],
        ];
    }

    public function testAllTilesByMsisFromTheDatabaseAreThoseFromTheImage(): void
    {
        $repository = $this->folder->path('repository');

        $run = ScriptRun::start(
            [Parts::msis(), 'patterns', '-b', '--source', 'mysql', '--res', '4', '-p', $repository],
            $this->environment,
        )->wait();

        self::assertSame(0, $run->exitCode, $run->errors);
        self::assertStringContainsString('(database ' . $this->environment['MSISF_DB_DATABASE'] . ')', $run->errors);
        self::assertAllPatternsOfMsis($repository);
    }

    /** @dataProvider forms */
    public function testTilesWithMarginOrInTheThesisFormAreThoseOfMsis(string $margin, string $format): void
    {
        $reference = $this->folder->path('msis');
        $label = preg_replace('/IMG$/', 'LBL', Parts::ldem4Image());
        $msis = ScriptRun::start([
            Parts::msis(), 'patterns', '-b', '--ldem', $label, '-p', $reference, '--margin', $margin, '--format', $format,
        ])->wait();
        self::assertSame(0, $msis->exitCode, $msis->errors);

        $run = $this->generate([
            '--lat=75:90', '--lon=345:15', "--margin=$margin", "--format=$format", '--repository', $this->folder->path('php'),
        ]);

        self::assertSame(0, $run->exitCode, $run->errors);
        $made = array_values(array_diff(scandir($this->folder->path('php/4')), ['.', '..']));
        self::assertCount(3 * 6, $made);
        foreach ($made as $name) {
            self::assertFileEquals("$reference/4/$name", $this->folder->path("php/4/$name"));
        }
    }

    public static function forms(): array
    {
        return ['the thesis\'s own' => ['0.5', 'mesh'], 'mesh2 with a margin' => ['0.3', 'mesh2']];
    }

    public function testRunAgainKeepsGoodPatternsAndMakesDamagedOnesAgain(): void
    {
        $repository = $this->folder->path('repository');
        $range = ['--lat=-10:10', '--lon=0:40', '--repository', $repository];
        $this->generate($range);
        $files = glob("$repository/4/*.inc");
        self::assertCount(4 * 8, $files);
        file_put_contents($files[0], substr((string) file_get_contents($files[0]), 0, -1));
        unlink($files[1]);
        touch($files[2], 1_000_000_000);

        $again = $this->generate($range);
        clearstatcache();

        self::assertStringContainsString(' 2 patterns made, 30 were there', $again->errors);
        self::assertSame([], ReferencePatterns::ldem4()->differencesIn($repository, wantAll: false));
        self::assertSame(1_000_000_000, filemtime($files[2]));
        self::assertStringContainsString(' 32 patterns made, 0 were there', $this->generate([...$range, '--no-resume'])->errors);
    }

    public function testUserWhoMayOnlyReadIsEnough(): void
    {
        $database = $this->environment['MSISF_DB_DATABASE'];
        foreach (["CREATE OR REPLACE USER reader@localhost IDENTIFIED BY 'geheim-7x!'", "GRANT SELECT ON $database.* TO reader@localhost"] as $sql) {
            PrivateServer::shared()->execute($this->environment, $sql);
        }
        $run = $this->generate(
            ['--lat=0', '--lon=0', '--repository', $this->folder->path('r')],
            ['MSISF_DB_USER' => 'reader', 'MSISF_DB_PASSWORD' => 'geheim-7x!'],
        );

        self::assertSame(0, $run->exitCode, $run->errors);
        self::assertStringNotContainsString('geheim', $run->errors . $run->output);
    }

    public function testTwoGeneratorsAndMsisInOneRepositoryGiveTheSamePatternsWithoutAnError(): void
    {
        $repository = $this->folder->path('repository');
        $label = preg_replace('/IMG$/', 'LBL', Parts::ldem4Image());
        $runs = [
            $this->start([...self::NORTH, '--repository', $repository]),
            $this->start([...self::NORTH, '--repository', $repository, '--query=spatial']),
            ScriptRun::start([Parts::msis(), 'patterns', '-b', '--ldem', $label, '-p', $repository]),
        ];
        foreach ($runs as $run) {
            self::assertSame(0, $run->wait()->exitCode, $run->errors);
        }
        self::assertAllPatternsOfMsis($repository);
    }

    /** The published example of thesis section 9.2. */
    public function testSceneOfSection92FromPatternsOfTheDatabaseIsTheSameImage(): void
    {
        $repository = $this->folder->path('repository');
        self::assertSame(0, $this->generate(['--all', '--jobs=2', '--query=grid', '--repository', $repository])->exitCode);

        $fromDatabase = $this->render($repository, 'database');
        $fromImage = $this->render(ReferencePatterns::ldem4()->repository(), 'image');

        self::assertAllPatternsOfMsis($repository);
        self::assertFileEquals($fromImage, $fromDatabase);
    }

    /** @return string path of the image */
    private function render(string $repository, string $name): string
    {
        $run = ScriptRun::start([
            Parts::msis(), '--batch', '--pov-path', Parts::povray(),
            '--fixed-state', '{55289,2E6,2E6,0,-2.391176183943345e-001,+9.904576054128762e-002,+3.696438106143861e-001,+8.923991008325228e-001}',
            '--ldem', (string) preg_replace('/IMG$/', 'LBL', Parts::ldem4Image()), '--ephemeris', 'builtin',
            '--width', '256', '--height', '256', '--pattern-repos', $repository,
            '--output-dir', $this->folder->path($name), '--output-name', 'scene',
        ])->wait();
        self::assertSame(0, $run->exitCode, $run->errors);
        $images = glob($this->folder->path("$name/*.png"));
        self::assertCount(1, $images);

        return $images[0];
    }
}
