using Msisf.App.Rendering;
using Xunit;

namespace Msisf.App.Tests.Rendering;

public class ProcessSlotsTests
{
    [Fact]
    public async Task TakeAsync_SmallOnes_RunTwiceAsManyAtOnceAsLargeOnes()
    {
        using ProcessSlots slots = new(large: 2, small: 4);
        for (int process = 0; process < 4; process++)
        {
            await slots.TakeAsync(isSmall: true, CancellationToken.None);
        }

        Assert.False(slots.TakeAsync(isSmall: true, CancellationToken.None).IsCompleted);
    }

    [Fact]
    public async Task TakeAsync_LargeOne_WaitsForRoomAndLeavesItAgain()
    {
        using ProcessSlots slots = new(large: 2, small: 4);
        IDisposable small = await slots.TakeAsync(isSmall: true, CancellationToken.None);
        IDisposable large = await slots.TakeAsync(isSmall: false, CancellationToken.None);
        Task<IDisposable> second = slots.TakeAsync(isSmall: false, CancellationToken.None);
        Assert.False(second.IsCompleted);

        small.Dispose();
        (await second).Dispose();
        large.Dispose();

        await slots.TakeAsync(isSmall: false, CancellationToken.None);
        await slots.TakeAsync(isSmall: false, CancellationToken.None);
    }

    [Fact]
    public async Task TakeAsync_CancelledWithHalfOfItsRoom_GivesThatBack()
    {
        using ProcessSlots slots = new(large: 1, small: 2);
        using CancellationTokenSource source = new();
        IDisposable small = await slots.TakeAsync(isSmall: true, CancellationToken.None);
        Task<IDisposable> large = slots.TakeAsync(isSmall: false, source.Token);

        await source.CancelAsync();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => large);
        small.Dispose();

        await slots.TakeAsync(isSmall: false, CancellationToken.None);
    }
}
