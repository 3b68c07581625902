<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Ldem;

use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Ldem\PdsLabelParser;
use Msisf\Scripts\Ldem\PdsObject;
use PHPUnit\Framework\TestCase;

final class PdsLabelParserTest extends TestCase
{
    public function testParseObjectsAndGroupsKeepTheirOwnKeywords(): void
    {
        $label = self::parse(
            "LINES = 1\nOBJECT = FILE\n LINES = 2\n GROUP = PART\n  LINES = 3\n END_GROUP = PART\n LAST = 4\nEND_OBJECT\nEND"
        );

        self::assertSame('1', $label->requiredText('LINES'));
        self::assertSame(['2', '4'], [$label->findObject('FILE')->requiredText('LINES'), $label->findObject('FILE')->requiredText('LAST')]);
        self::assertSame(['3', 5], [$label->findObject('PART')->requiredText('LINES'), $label->findObject('PART')->line]);
        self::assertNull($label->find('LAST'));
    }

    /** @dataProvider values */
    public function testParseValueIsReadWithUnitQuotesAndItems(string $written, string $expected): void
    {
        self::assertSame($expected, (string) self::parse("A = $written\nB = next\nEND")->required('A'));
    }

    public static function values(): array
    {
        return [
            'number with a unit' => ['4.0 < pix/deg >', '4.0 <pix/deg>'],
            'text over several lines' => ["\"  a\r\n      b \"", 'a b'],
            'sequence over several lines' => ["(\"F.IMG\",\r\n 3 <BYTES>)", '(F.IMG, 3 <BYTES>)'],
            'set' => ["{1,'b'}", '(1, b)'],
            'nested' => ['((1, 2), (3, 4)) <m>', '((1, 2), (3, 4))'],
            'empty sequence' => ['()', '()'],
        ];
    }

    public function testParseAttachedLabelWhatFollowsItsEndIsNotLookedAt(): void
    {
        $label = self::parse("A = 1\r\nEND\r\n\"\0\xff /* <");

        self::assertSame('1', $label->requiredText('A'));
    }

    public function testParseStandardFormattedDataUnitMayStandFirst(): void
    {
        $label = PdsLabelParser::parse("CCSD3ZF0000100000001NJPL3IF0PDSX00000001 = SFDU_LABEL\nA = 1\nEND", 'x.LBL');

        self::assertSame('1', $label->requiredText('A'));
    }

    /** @dataProvider depths */
    public function testParseDepthHasALimit(int $objects, ?string $message): void
    {
        if ($message !== null) {
            $this->expectException(BadInputException::class);
            $this->expectExceptionMessage($message);
        }
        $label = self::parse(str_repeat("OBJECT = O\n", $objects) . "A = deep\n" . str_repeat("END_OBJECT = O\n", $objects) . 'END');
        for ($object = $label; $objects > 0; $objects--) {
            $object = $object->findObject('O');
        }
        self::assertSame('deep', $object->requiredText('A'));
    }

    public static function depths(): array
    {
        return ['the most' => [31, null], 'one more' => [32, 'objects are nested too deep']];
    }

    /** @dataProvider wrongLabels */
    public function testParseWrongLabelIsRefusedWithLineAndNeed(string $text, string $message): void
    {
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage($message);
        self::parse($text);
    }

    public static function wrongLabels(): array
    {
        return [
            'no sign' => ["A 1\nEND", "x.LBL, line 2: '1'; '=' after A is needed"],
            'no value' => ["A =\nEND_OBJECT = 1\nEND", "line 3: '='; a keyword is needed"],
            'a sign as value' => ['A = = 1', "line 2: '='; a value is needed"],
            'no comma' => ['A = (1 2)', "line 2: '2'; ',' or ')' is needed"],
            'the wrong bracket' => ['A = (1}', "line 2: '}'; ',' or ')' is needed"],
            'quoted keyword' => ['"A" = 1', "line 2: 'A'; a keyword is needed"],
            'end of another object' => ["OBJECT = A\nEND_OBJECT = B\nEND", "line 3: 'B'; END_OBJECT = A is needed first (line 2 opens it)"],
            'end of a group' => ["OBJECT = A\nEND_GROUP = A\nEND", "line 3: 'END_GROUP'; END_OBJECT = A is needed first"],
            'end of the label in an object' => ["OBJECT = A\nEND", "line 3: 'END'; END_OBJECT = A is needed first"],
            'end of no object' => ["END_OBJECT = A\nEND", "line 2: 'END_OBJECT'; no object is open here"],
            'no end' => ['A = 1', 'line 2: the label ends; a keyword is needed'],
        ];
    }

    private static function parse(string $text): PdsObject
    {
        return PdsLabelParser::parse("PDS_VERSION_ID = PDS3\n$text", 'x.LBL');
    }
}
