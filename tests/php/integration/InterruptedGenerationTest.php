<?php

declare(strict_types=1);

namespace Msisf\Tests\Integration;

use Msisf\Tests\Support\PrivateServer;
use Msisf\Tests\Support\ReferencePatterns;

/** Whatever is killed whenever: the same command run again ends with the patterns of an undisturbed run. */
final class InterruptedGenerationTest extends GenerationTestCase
{
    private const SEED = 20120222;

    /**
     * One process makes half of the Moon in the time in which two make all of it.
     *
     * @dataProvider jobs
     */
    public function testGeneratorKilledAtRandomMomentsLosesNothing(int $jobs): void
    {
        mt_srand(self::SEED + $jobs);
        $repository = $this->folder->path('repository');
        $command = [...($jobs === 1 ? self::NORTH : ['--all']), "--jobs=$jobs", '--repository', $repository];
        $killed = 0;
        for ($i = 0; $i < 5; $i++) {
            $run = $this->start($command);
            usleep(mt_rand(30_000, 600_000));
            $killed += (int) $run->isRunning();
            $run->kill();
            $run->wait();
            if (is_dir("$repository/4")) {
                self::assertSame([], ReferencePatterns::ldem4()->differencesIn($repository, wantAll: false));
            }
        }
        self::assertGreaterThanOrEqual(3, $killed);

        $run = $this->generate($command);

        self::assertSame(0, $run->exitCode, $run->errors);
        if ($jobs === 1) {
            self::assertNorthernPatternsOfMsis($repository);
        } else {
            self::assertAllPatternsOfMsis($repository);
        }
    }

    public static function jobs(): array
    {
        return [[1], [2]];
    }

    public function testServerKilledAtRandomMomentsIsSaidClearlyAndLosesNothing(): void
    {
        mt_srand(self::SEED);
        $repository = $this->folder->path('repository');
        $command = [...self::NORTH, '--jobs=2', '--query=spatial', '--repository', $repository];
        for ($i = 0; $i < 3; $i++) {
            $run = $this->start([...$command, '--no-resume']);
            usleep(mt_rand(200_000, 700_000));
            PrivateServer::shared()->kill();
            $run->wait();
            PrivateServer::shared()->restart();

            self::assertRefused(3, 'error: database /', $run);
            self::assertMatchesRegularExpression('/The server has gone away|Is the server running/', $run->errors);
        }

        $run = $this->generate($command);

        self::assertSame(0, $run->exitCode, $run->errors);
        self::assertNorthernPatternsOfMsis($repository);
    }
}
