using Msisf.App.Serving;
using Xunit;

namespace Msisf.App.Tests.Serving;

/// <summary>What was used last stays, and what is in use is never disposed.</summary>
public sealed class SharedCacheTests
{
    [Fact]
    public void Rent_SameKey_MakesOneValue()
    {
        int made = 0;
        using SharedCache<Resource> cache = new(2);

        using SharedCache<Resource>.Lease first = cache.Rent("a", Make);
        using SharedCache<Resource>.Lease second = cache.Rent("a", Make);

        Assert.Same(first.Value, second.Value);
        Assert.Equal(1, made);

        Resource Make()
        {
            made++;
            return new Resource();
        }
    }

    [Fact]
    public void Rent_MoreThanFit_DisposesTheOneUsedLongestAgo()
    {
        using SharedCache<Resource> cache = new(2);
        Resource a = Use(cache, "a");
        Resource b = Use(cache, "b");
        Use(cache, "a");

        Use(cache, "c");

        Assert.True(b.IsDisposed);
        Assert.False(a.IsDisposed);
        Assert.Equal(2, cache.Count);
    }

    [Fact]
    public void Rent_AllInUse_DisposesNoneUntilOneIsGivenBack()
    {
        using SharedCache<Resource> cache = new(1);
        SharedCache<Resource>.Lease a = cache.Rent("a", () => new Resource());
        SharedCache<Resource>.Lease b = cache.Rent("b", () => new Resource());
        Assert.False(a.Value.IsDisposed || b.Value.IsDisposed);

        a.Dispose();
        a.Dispose(); // twice counts once

        Assert.True(a.Value.IsDisposed);
        Assert.False(b.Value.IsDisposed);
        b.Dispose();
        Assert.False(b.Value.IsDisposed);
    }

    [Fact]
    public void Rent_FailedValue_IsMadeAgain()
    {
        using SharedCache<Resource> cache = new(1);
        Assert.Throws<InvalidOperationException>(() => cache.Rent("a", () => throw new InvalidOperationException()));

        using SharedCache<Resource>.Lease lease = cache.Rent("a", () => new Resource());

        Assert.False(lease.Value.IsDisposed);
    }

    private static Resource Use(SharedCache<Resource> cache, string key)
    {
        using SharedCache<Resource>.Lease lease = cache.Rent(key, () => new Resource());
        return lease.Value;
    }

    private sealed class Resource : IDisposable
    {
        public bool IsDisposed { get; private set; }

        public void Dispose() => IsDisposed = true;
    }
}
