<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Database;

use Closure;
use Msisf\Scripts\Database\Statement;
use PDO;
use PDOStatement;
use PHPUnit\Framework\TestCase;

final class StatementTest extends TestCase
{
    public function testExecuteBindsEachValueWithItsTypeAndCountsRows(): void
    {
        $bound = [];
        $pdo = $this->createMock(PDOStatement::class);
        $pdo->method('bindValue')->willReturnCallback(static function (int|string $place, mixed $value, int $type) use (&$bound): bool {
            $bound[] = [$place, $value, $type];

            return true;
        });
        $pdo->expects(self::once())->method('execute')->willReturn(true);
        $pdo->method('rowCount')->willReturn(3);
        $wraps = 0;
        $wrap = static function (Closure $work) use (&$wraps): mixed {
            $wraps++;

            return $work();
        };

        self::assertSame(3, (new Statement($pdo, $wrap))->execute([5, 1737400.5, 'a', null, ':name' => 7]));
        self::assertSame(
            [[1, 5, PDO::PARAM_INT], [2, 1737400.5, PDO::PARAM_STR], [3, 'a', PDO::PARAM_STR], [4, null, PDO::PARAM_NULL], [':name', 7, PDO::PARAM_INT]],
            $bound,
        );
        self::assertSame(1, $wraps);
    }
}
