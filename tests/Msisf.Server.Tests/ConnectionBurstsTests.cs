using Xunit;

namespace Msisf.Server.Tests;

/// <summary>Programs of one address, told apart by when they connect.</summary>
public sealed class ConnectionBurstsTests
{
    private readonly ConnectionBursts _bursts = new(TimeSpan.FromSeconds(1.0));

    [Fact]
    public void ConnectionsAfterOneAnother_AreOfOneProgram_HoweverLongTheRowIs()
    {
        long[] numbers = [.. Enumerable.Range(0, 65).Select(i => Opened("a", 0.9 * i))];

        Assert.Single(numbers.Distinct());
    }

    [Fact]
    public void ConnectionThatComesAlone_IsOfAnotherProgram()
    {
        Assert.Equal(4, new[] { Opened("a", 0.0), Opened("a", 1.1), Opened("a", 2.3), Opened("a", 9.0) }.Distinct().Count());
    }

    [Fact]
    public void ConnectionsOfTwoAddresses_AreOfTwoPrograms()
    {
        long first = Opened("a", 0.0);
        long other = Opened("b", 0.1);

        Assert.NotEqual(first, other);
        Assert.Equal(first, Opened("a", 0.2));
    }

    /// <summary>A program with a connection for each request is one, however long its images take and whoever comes in between.</summary>
    [Fact]
    public void ConnectionAfterTheEndOfAnother_IsOfThatOnesProgram()
    {
        long busy = Opened("a", 0.0);
        long other = Opened("a", 5.0);
        _bursts.Closed("a", busy, TimeSpan.FromSeconds(10.0));
        long next = Opened("a", 10.1);

        Assert.NotEqual(busy, other);
        Assert.Equal(busy, next);
    }

    private long Opened(string address, double seconds) => _bursts.Opened(address, TimeSpan.FromSeconds(seconds));
}
