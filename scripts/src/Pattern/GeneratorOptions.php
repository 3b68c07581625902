<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Msisf\Scripts\Console\Option;
use Msisf\Scripts\Console\OptionParser;
use Msisf\Scripts\Console\ParsedOptions;
use Msisf\Scripts\Database\ConnectionOptions;
use Msisf\Scripts\Database\ConnectionSettings;
use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Exception\UsageException;
use Msisf\Scripts\Ldem\Resolution;

/** What generate_pattern.php is asked for. */
final class GeneratorOptions
{
    private const MOST_JOBS = 256;

    /** @param array{int, int}|null $share this process's number, from 1, and how many there are; null for the first process */
    private function __construct(
        public readonly Resolution $resolution,
        public readonly TileRange $range,
        public readonly int $jobs,
        public readonly string $repository,
        public readonly bool $makeAll,
        public readonly QueryMethod $query,
        public readonly PatternOptions $pattern,
        public readonly ConnectionSettings $connection,
        public readonly ?array $share,
    ) {
    }

    public static function parser(): OptionParser
    {
        return new OptionParser(
            "Makes surface patterns (5 x 5 degree meshes for POV-Ray) of an elevation model in the database.\n"
            . 'Usage: php generate_pattern.php --all | --lat FROM:TO --lon FROM:TO [options]',
            [
                Option::value('res', 'RESOLUTION', 'Resolution of the elevation model in px/deg.', '4'),
                Option::flag('all', 'All 2,592 patterns of the Moon.'),
                Option::value('lat', 'FROM:TO', 'Only patterns that touch these latitudes, degrees from -90 to 90.'),
                Option::value('lon', 'FROM:TO', 'Only patterns that touch these east longitudes, degrees from 0 to 360; '
                    . '350:10 runs over the prime meridian.'),
                Option::value('jobs', 'N', 'Processes to share the work.', '1'),
                Option::value('repository', 'FOLDER', 'Folder of the patterns.', './pattern-repository'),
                Option::flag('resume', 'Keep patterns that are there and right, make the others (the default).'),
                Option::flag('no-resume', 'Make patterns again that are there and right.'),
                Option::value('query', 'grid|spatial', 'Ask the database by key ranges, or by the spatial index; the patterns are '
                    . 'the same.', 'grid'),
                Option::value('margin', 'DEGREES', 'Overlap with the neighbours, for scenes of 2012; none is needed, at most 1.', '0'),
                Option::value('format', 'mesh2|mesh', 'Form of the patterns: exact and compact, or the thesis\'s text form.', 'mesh2'),
                ...ConnectionOptions::all(),
                Option::value('worker', 'K/N', 'For the script itself: make the K-th of N shares and report on stdout.'),
            ],
        );
    }

    /** @throws UsageException|BadInputException an option is wrong */
    public static function read(ParsedOptions $options): self
    {
        $isPart = $options->has('lat') || $options->has('lon');
        if ($isPart === $options->has('all')) {
            throw new UsageException($isPart
                ? '--all and --lat or --lon contradict each other. Give one of them.'
                : 'no tiles are named. Give --all, or --lat FROM:TO and --lon FROM:TO; --help lists the options.');
        }
        if ($options->has('resume') && $options->has('no-resume')) {
            throw new UsageException('--resume and --no-resume contradict each other. Give one of them.');
        }
        $repository = $options->requiredText('repository');
        if ($repository === '' || str_contains($repository, "\0")) {
            throw UsageException::badValue('repository', '', 'the name of a folder is needed');
        }

        return new self(
            Resolution::from((int) $options->choice('res', array_map(strval(...), array_column(Resolution::cases(), 'value')))),
            TileRange::parse($options->text('lat'), $options->text('lon')),
            $options->integer('jobs', 1, self::MOST_JOBS),
            $repository,
            $options->has('no-resume'),
            QueryMethod::from($options->choice('query', array_column(QueryMethod::cases(), 'value'))),
            PatternOptions::parse(
                $options->requiredText('margin'),
                PatternFormat::from($options->choice('format', array_column(PatternFormat::cases(), 'value'))),
            ),
            ConnectionOptions::settings($options),
            self::share($options->text('worker')),
        );
    }

    /** @return array{int, int}|null */
    private static function share(?string $text): ?array
    {
        if ($text === null) {
            return null;
        }
        if (preg_match('~^([1-9][0-9]{0,2})/([1-9][0-9]{0,2})$~D', $text, $parts) !== 1 || (int) $parts[1] > (int) $parts[2]) {
            throw UsageException::badValue('worker', $text, 'K/N with K from 1 to N is needed');
        }

        return [(int) $parts[1], (int) $parts[2]];
    }
}
