using System.Data.Common;

namespace Msisf.MySql.Tests;

internal sealed class NoSuchTableException() : DbException("Table 'x' doesn't exist");
