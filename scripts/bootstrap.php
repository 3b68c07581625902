<?php

declare(strict_types=1);

// Loads classes of Msisf\Scripts and makes the scripts independent of php.ini and of "php -d".
// (auto_prepend_file and disable_functions act before this and can't be undone.)

if (PHP_VERSION_ID < 80200) {
    fwrite(STDERR, 'msisf: error: PHP ' . PHP_VERSION . "; 8.2 or later is needed. Install php-cli 8.2.\n");
    exit(3);
}

// -1: the shortest text that reads back as the same double. With the default 14 a bound or echoed coordinate loses digits.
ini_set('precision', '-1');
ini_set('serialize_precision', '-1');
ini_set('display_errors', '0');
ini_set('log_errors', '0');
ini_set('html_errors', '0');
ini_set('memory_limit', '512M');
ini_set('max_execution_time', '0');
ini_set('default_charset', 'UTF-8');
ini_set('zend.exception_ignore_args', '1');
ini_set('zend.assertions', '0');
error_reporting(E_ALL);
setlocale(LC_ALL, 'C');
date_default_timezone_set('UTC');
while (ob_get_level() > 0) {
    ob_end_flush();
}

// A notice or warning of PHP is a failure that nobody has thought of: it ends the script with a stack trace, exit code 70.
// Where one is expected (a missing file), the call is silenced with @ and its result checked.
set_error_handler(static function (int $severity, string $message, string $file, int $line): bool {
    if ((error_reporting() & $severity) === 0) {
        return false;
    }
    throw new ErrorException($message, 0, $severity, $file, $line);
});

spl_autoload_register(static function (string $class): void {
    $prefix = 'Msisf\\Scripts\\';
    if (str_starts_with($class, $prefix)) {
        $path = __DIR__ . '/src/' . str_replace('\\', '/', substr($class, strlen($prefix))) . '.php';
        if (is_file($path)) {
            require $path;
        }
    }
});
