<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Pattern;

use Msisf\Scripts\Exception\UsageException;
use Msisf\Scripts\Ldem\Resolution;
use Msisf\Scripts\Pattern\GeneratorOptions;
use Msisf\Scripts\Pattern\PatternFormat;
use Msisf\Scripts\Pattern\QueryMethod;
use PHPUnit\Framework\TestCase;

final class GeneratorOptionsTest extends TestCase
{
    protected function setUp(): void
    {
        putenv('MSISF_DB_USER=me');
    }

    protected function tearDown(): void
    {
        putenv('MSISF_DB_USER');
    }

    public function testReadWhatIsNotGivenHasItsDefault(): void
    {
        $options = self::read('--all');

        self::assertSame(
            [Resolution::Px4, 2592, 1, './pattern-repository', false, QueryMethod::Grid, PatternFormat::Mesh2, 0, null],
            [
                $options->resolution, count($options->range->tiles()), $options->jobs, $options->repository, $options->makeAll,
                $options->query, $options->pattern->format, $options->pattern->marginSamples(4), $options->share,
            ],
        );
    }

    public function testReadWhatIsGivenCounts(): void
    {
        $options = self::read(
            '--lat=0:10', '--lon=350:5', '--res=16', '--jobs=8', '--repository=r', '--no-resume', '--query=spatial', '--format=mesh',
            '--margin=0.5', '--worker=3/8',
        );

        self::assertSame(
            [Resolution::Px16, 6, 8, 'r', true, QueryMethod::Spatial, PatternFormat::Mesh, 8, [3, 8]],
            [
                $options->resolution, count($options->range->tiles()), $options->jobs, $options->repository, $options->makeAll,
                $options->query, $options->pattern->format, $options->pattern->marginSamples(16), $options->share,
            ],
        );
    }

    /** @dataProvider wrongOptions */
    public function testReadWrongOrContradictoryOptionsAreRefused(array $arguments, string $message): void
    {
        $this->expectException(UsageException::class);
        $this->expectExceptionMessage($message);
        self::read(...$arguments);
    }

    public static function wrongOptions(): array
    {
        return [
            'no tiles' => [[], 'no tiles are named'],
            'all and some' => [['--all', '--lon=0:5'], '--all and --lat or --lon contradict each other'],
            'both ways to go on' => [['--all', '--resume', '--no-resume'], '--resume and --no-resume contradict each other'],
            'no folder' => [['--all', '--repository='], '--repository=: the name of a folder is needed'],
            'resolution without products' => [['--all', '--res=8'], '--res=8: one of 4, 16'],
            'no processes' => [['--all', '--jobs=0'], '--jobs=0: a whole number from 1 to 256 is needed'],
            'share beyond the last' => [['--all', '--worker=3/2'], '--worker=3/2: K/N with K from 1 to N is needed'],
            'share 0' => [['--all', '--worker=0/2'], '--worker=0/2: K/N'],
            'share of no number' => [['--all', '--worker=1/2/3'], '--worker=1/2/3: K/N'],
            'way to ask' => [['--all', '--query=fast'], '--query=fast: one of grid, spatial is needed'],
        ];
    }

    private static function read(string ...$arguments): GeneratorOptions
    {
        return GeneratorOptions::read(GeneratorOptions::parser()->parse($arguments));
    }
}
