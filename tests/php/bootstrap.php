<?php

declare(strict_types=1);

require dirname(__DIR__, 2) . '/scripts/bootstrap.php';

// Tests hold more in memory than the scripts may.
ini_set('memory_limit', '2G');

spl_autoload_register(static function (string $class): void {
    $prefix = 'Msisf\\Tests\\';
    if (str_starts_with($class, $prefix)) {
        $parts = explode('\\', substr($class, strlen($prefix)));
        $parts[0] = strtolower($parts[0]);
        $path = __DIR__ . '/' . implode('/', $parts) . '.php';
        if (is_file($path)) {
            require $path;
        }
    }
});
